(** The names of the features of solids: corners, faces, and parts with theirs. *)

open Scc_syntax
open Scc_describe

type modules = Ast.import -> Reading.t option
(** The text that an import names, if it can be read. *)

val of_solid : modules -> Reading.t -> Ast.solid -> string list
(** The features of a solid as written in a text: of a part [p], [p] and [p.f] for each feature [f] of it. *)

val of_name : modules -> Reading.t -> qualifier:string option -> string -> corners:int option -> string list
(** The features of the shape, compound or predefined solid of this name. [corners] is the first argument of a
    predefined solid. *)

val all : Reading.t -> string list
(** The features of all templates that a text declares. *)
