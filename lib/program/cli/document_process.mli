(** The processes behind [scc serve]. Each answers requests, line by line, over standard input and output, by
    the service of [scc oracle]. *)

open Scc_verdicts

val desk : path:string -> Exit_code.t
(** Answers each line by a line (an empty one for a notification) until the input ends. Files that a model names
    are read beside [path]. *)

val document : Viewed.options -> Exit_code.t
(** Makes a document of the text in the first line of the input, a JSON string. Its output is lines
    [{"progress": …}], and then [{"refused": diagnostics}], which ends the process, or [{"ready": …}] with the
    verdicts.

    Then it answers as {!desk}, with the methods of {!Scc_live.Live} and the model as the handle [m1]. The line
    [document] is answered by the document as it is then. While the document is made, SIGINT ends all work that
    can be ended early. *)
