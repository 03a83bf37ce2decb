(** The page that shows a document: one file of HTML with all that it needs, which opens from disk and asks nobody
    for anything. Its policy lets nothing else in, and no text of a model is markup in it. *)

val write : title:string -> ((string -> unit) -> unit) -> (string -> unit) -> unit
(** [write ~title data put]: the page with what [data] writes, which is JSON. *)
