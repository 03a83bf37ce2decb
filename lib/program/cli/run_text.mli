(** States and transitions in words, for people. *)

open Scc_exact
open Scc_calculus
open Scc_semantics

val number : full:bool -> Rat.t -> string
(** With all its digits if [full], and else by {!Scc_exchange.Short_text.exact}. *)

val label : ?full:bool -> Model.t -> Transition.label -> string
(** What happens: ["p and q collide and bind by <a, {p.right, q.left}>"]. *)

val passes : ?full:bool -> int -> Rat.t -> string
(** ["time passes 8 times by 1/4"]. *)

val listed : string list -> string
(** ["p, q and r"]. *)

val name : Model.t -> int -> string
(** Of a leaf. *)

val fixed : Model.t -> State.process -> bool
val does_nothing : Model.t -> State.process -> bool
(** Each of its leaves behaves as [nil]. *)

val state : ?full:bool -> ?aside:(State.process -> string option) -> Model.t -> State.t -> string list
(** A line for each process, and one more for each leaf of a process of several. Those that are put [aside] are
    only named, in one line for each word that they are put aside with, when there are several. Long lists and
    long behaviours are cut, and say so. If [full] nothing is cut or put aside. *)

val rounded : Scc_engine.Totals.t * Scc_engine.Totals.t -> string list
(** What rule Round has added to the totals of a network, from close bounds. *)
