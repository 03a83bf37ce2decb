(** The processes behind [scc serve]: each answers questions, line by line, over standard input and output, by the
    service of [scc oracle]. *)

open Scc_session

val desk : path:string -> Exit_code.t
(** Answers each line by a line (an empty one to a notification), until the input ends. Files that a model names
    are read beside [path]. *)

val document : Viewed.options -> Exit_code.t
(** Makes a document of the text that the first line of the input is, a JSON string, and tells it by lines: each
    [{"progress": …}], then [{"refused": diagnostics}], which ends it, or [{"ready": …}] with the verdicts. Then it
    answers as {!desk}, with the methods of {!Scc_live.Live} and the model as the handle [m1]. The line [document]
    is answered by the document as it is now. While it is made, SIGINT ends what can be ended early. *)
