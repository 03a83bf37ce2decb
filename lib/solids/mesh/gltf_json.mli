(** The JSON of a glTF file, with numbers as they are written. A fault (SC0320) is located at the start of the
    file, as JSON values have no places here. Its message has the path of the value: [accessors[3].count]. *)

open Scc_base
open Scc_exact

type t

val parse : path:string -> string -> (t, Diag.t) result
(** The object of the whole file. Nesting is at most 100 deep, which bounds the stack. A name that an object has
    twice is a fault. *)

val place : t -> string
(** Where a value is, as in ["nodes[0].mesh"]. *)

val fail : t -> ('a, unit, string, ('b, Diag.t) result) format4 -> 'a
(** [fail v format …] is a fault at this value (SC0320). *)

val member : string -> t -> t option
(** [member name v] is the member of an object. [None] if it is absent or null, or if [v] is no object. *)

val needed : string -> t -> (t, Diag.t) result
(** [needed name v] is the member of an object; a fault if {!member} has none. *)

val is_object : t -> (unit, Diag.t) result
(** A fault if the value is no object. *)

val items : string -> t -> (t array, Diag.t) result
(** [items name v] are the elements of the array that is a member of [v]; none if the member is absent. A
    member that is no array is a fault. *)

val truth : string -> t -> (bool, Diag.t) result
(** [truth name v] is the truth value that is a member of [v], or false if the member is absent; a fault for any
    other value. *)

val keys : t -> string list
(** The names of the members of an object; none for other values. *)

val nth : 'a array -> what:string -> t -> ('a * int, Diag.t) result
(** [nth list ~what v] is the element of [list] whose index is the value [v], and the index. An index beyond
    the list is a fault, which [what] names. *)

val number : t -> (Rat.t, Diag.t) result
(** The exact value of a number, as {!Text.coordinate} reads it; a fault if the value is no number. *)

val numbers : int -> t -> (Rat.t array, Diag.t) result
(** [numbers n v] are the exact values of an array of [n] numbers; a fault for any other value. *)

val index : t -> (int, Diag.t) result
(** The value as an integer from 0 to 2{^31} - 1; a fault for any other value. *)

val index_or : int -> string -> t -> (int, Diag.t) result
(** [index_or default name v] is {!index} of a member of [v], or [default] if that is absent. *)

val text : t -> (string, Diag.t) result
(** The value of a string, with its escapes resolved; a fault if the value is no string. *)

val of_index : t -> int -> t
(** [of_index v i] is the index [i] as a value, with the path of [v] for its faults. *)
