(** Pages: files of HTML with all that they need. Their policies let nothing else in, and no text of a model is
    markup in them. *)

val write : ?served:bool -> title:string -> ((string -> unit) -> unit) -> (string -> unit) -> unit
(** [write ~title data put]: the page that shows a document, with what [data] writes, which is JSON. It opens from
    disk and asks nobody for anything; one that is [served] asks the server that it came from. *)

val desk : title:string -> ((string -> unit) -> unit) -> (string -> unit) -> unit
(** The page on which a model is written and its documents are shown, likewise. *)

val solid : title:string -> ((string -> unit) -> unit) -> (string -> unit) -> unit
(** The page that shows a solid ({!Solid_page}), likewise. *)
