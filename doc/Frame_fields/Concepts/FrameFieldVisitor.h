/*!
\ingroup PkgFrame_fieldsConcepts
\cgalConcept

The concept `FrameFieldVisitor` describes what `CGAL::Frame_fields::cad_frame_field()` tells its caller while it runs,
for example to show progress. An object of this type is passed as named parameter `visitor`.

\cgalRefines{CopyConstructible}

\cgalHasModelsBegin
\cgalHasModels{CGAL::Frame_fields::Default_frame_field_visitor}
\cgalHasModelsEnd
*/
class FrameFieldVisitor
{
public:

/*!
is called in the calling thread when `stage` starts, once for each stage in the order of `CGAL::Frame_fields::Stage`.
Stages after a failure are not started, nor is `CGAL::Frame_fields::Stage::RELAXATION` if the field is not relaxed. An
exception that is thrown here leaves `CGAL::Frame_fields::cad_frame_field()` before any output was written.
*/
void start_stage(CGAL::Frame_fields::Stage stage);

}; /* end FrameFieldVisitor */
