(** Pages: HTML files with all that they need. Their content security policies block everything else, and no
    text of a model is markup in them. *)

val write : ?served:bool -> title:string -> ((string -> unit) -> unit) -> (string -> unit) -> unit
(** [write ~title data put] is the page that shows a document; [data] writes it as JSON. The page opens from
    disk and makes no requests. If [served] (default: false), it sends requests to its server. *)

val desk : title:string -> ((string -> unit) -> unit) -> (string -> unit) -> unit
(** The page of an editor for a model and its documents, with the JSON that [data] writes. It sends requests to
    its server. *)

val solid : title:string -> ((string -> unit) -> unit) -> (string -> unit) -> unit
(** The page that shows a solid ({!Solid_page}), with the JSON that [data] writes. It makes no requests. *)
