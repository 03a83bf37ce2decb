(** States and transitions in words. *)

open Scc_exact
open Scc_calculus
open Scc_semantics

val number : full:bool -> Rat.t -> string
(** The number with all its digits if [full], and by {!Scc_runs.Short_text.exact} otherwise. *)

val label : ?full:bool -> Model.t -> Transition.label -> string
(** The event in words: ["p and q collide and bind by <a, {p.right, q.left}>"]. *)

val passes : ?full:bool -> int -> Rat.t -> string
(** Several passings of equal time: ["time passes 8 times by 1/4"]. *)

val fixed : Model.t -> State.process -> bool
(** [fixed m p] is true if the process has a fixed leaf. *)

val does_nothing : Model.t -> State.process -> bool
(** [does_nothing m p] is true if each leaf of the process behaves as [nil]. *)

val state : ?full:bool -> ?aside:(State.process -> string option) -> Model.t -> State.t -> string list
(** A line for each process, and one more for each leaf of a process of several. If [aside] gives words for two
    or more processes, these are only named, in one line for each word. Long lists and long behaviours are cut,
    and marked as such. If [full], nothing is cut or put aside. *)

val rounded : Scc_engine.Totals.t * Scc_engine.Totals.t -> string list
(** The amounts that rule Round has added to the totals of a network, from close bounds. *)
