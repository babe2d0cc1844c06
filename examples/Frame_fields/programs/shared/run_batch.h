#ifndef FRAME_FIELDS_PROGRAMS_RUN_BATCH_H
#define FRAME_FIELDS_PROGRAMS_RUN_BATCH_H

#include "Batch_options.h"
#include "Failure.h"

// Computes the models of a list, each in a process of its own.
Exit_code run_batch(const Batch_options& options);

#endif // FRAME_FIELDS_PROGRAMS_RUN_BATCH_H
