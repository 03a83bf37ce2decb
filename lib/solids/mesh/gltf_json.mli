(** The JSON of a glTF file, with numbers as they are written. A fault (SC0320, at the start of the file, as
    what is read has no places) tells by a path where it is: [accessors[3].count]. *)

open Scc_base
open Scc_exact

type t

val parse : path:string -> string -> (t, Diag.t) result
(** The object of the whole file. Nesting is at most 100 deep, so that the stack is bounded. *)

val fail : t -> ('a, unit, string, ('b, Diag.t) result) format4 -> 'a
(** A fault at this value. *)

val member : string -> t -> t option
(** Of an object; [None] where it is absent, or null, or the value is no object. *)

val needed : string -> t -> (t, Diag.t) result
val items : string -> t -> (t array, Diag.t) result
(** Of the array that a member is; none when there is no such member. *)

val nth : 'a array -> what:string -> t -> ('a * int, Diag.t) result
(** The element that a value, an index, names. *)

val number : t -> (Rat.t, Diag.t) result
val numbers : int -> t -> (Rat.t array, Diag.t) result
(** Exactly so many, as written. *)

val index : t -> (int, Diag.t) result
(** An integer from 0 to 2{^31} - 1. *)

val index_or : int -> string -> t -> (int, Diag.t) result
(** Of a member that may be absent. *)

val text : t -> (string, Diag.t) result

val of_index : t -> int -> t
(** An index, as if it stood in the file. *)
