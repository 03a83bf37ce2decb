(** The tetrahedron of the tests as 3MF, whole and with faults. *)

val whole : string
(** The solid, with an element of an extension that is not known. *)

val files : (string * string * string) list
(** Name, path and text. *)

val mirrored : string
(** The tetrahedron in a mirror. *)

val models : string list
(** The XML in some, for {!packed}. *)

val packed : string -> string

val rels : string
(** The relationships of the package. *)

val package : ?rels:string -> string -> string
(** The package of a model. *)

val bad : (string * string * string * string) list
(** And where the fault is, with its code. *)
