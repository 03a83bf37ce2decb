(** The names of the features of solids: corners, faces, and parts with theirs. *)

open Scc_syntax
open Scc_describe

type modules = Ast.import -> Reading.t option
(** The text that an import names, if it can be read. *)

val of_name : modules -> Reading.t -> qualifier:string option -> string -> corners:int option -> string list
(** The features of the shape, compound or predefined solid of this name. [corners] is the first argument of a
    predefined solid. *)

val predefined : string -> corners:int option -> string list
(** The features of a predefined solid, such as [box]; none for any other name. *)

val number : Ast.expr -> int option
(** The value of an expression that is an integer as it is written. *)
