(** What each word of a document is, in the encoding of the protocol. *)

open Scc_json

val legend : Json.t
(** The kinds and marks of words. *)

val full : Session.t -> Json.t -> unit -> Json.t
(** All words, under an id. What the request is about is fixed at once, and the answer is computed by the last
    argument, perhaps in another process. *)

val delta : Session.t -> Json.t -> unit -> Json.t
(** What has changed since the answer with the id of the request, or all words if that id is not known; as {!full}.
*)

val within : Session.t -> Json.t -> Json.t
(** The words of a range. *)
