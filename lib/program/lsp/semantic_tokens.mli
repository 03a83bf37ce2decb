(** Semantic tokens (LSP 3.17): the kind of each word of a document, five integers for each token. *)

open Scc_json

val legend : Json.t
(** The kinds and modifiers of tokens, by their numbers. *)

val full : Session.t -> Json.t -> unit -> Json.t
(** [full session params] reads the document at once. The function that it returns computes all its tokens, with an
    id, and may be called in another process. The result is [`Null] for a document that is not open. *)

val delta : Session.t -> Json.t -> unit -> Json.t
(** [delta session params] is as {!full}, with an edit from the tokens of the answer with the id
    [previousResultId]. It is all tokens if that id is not known. *)

val within : Session.t -> Json.t -> Json.t
(** [within session params] is the tokens that meet the range of the request. *)
