(** The points of a sweep: all combinations of values of parameters. *)

open Scc_exact

(** A parameter with its values. *)
type axis = { name : string; values : Rat.t array  (** one or more *) }

(** All combinations of the values of these parameters. *)
type t = axis list

val most : int
(** The greatest number of points, and of values of one axis: a million. *)

val values : string -> (Rat.t array, string) result
(** The values of a text: ["3"], ["1/2, 1, 5"], ["1..10"] (integers, or steps of 1 from the first number) or
    ["0:2:1/8"] (from, to, step). The error is what is wrong with any other text. *)

val size : t -> Z.t
(** The number of points. *)

val point : t -> int -> (string * Rat.t) list
(** The values of the parameters at a point, from 0 on. The last axis changes fastest. *)
