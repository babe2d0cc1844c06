#include "quick_examples.h"

QUICK_EXAMPLES_FILES()
