(** Binding candidates (rule Bind, reading I-12): which channels of two touching leaves fit, and where. *)

open Scc_geometry
open Scc_calculus

type candidate = {
  bond : State.bond;  (** to be made *)
  continuations : (int * Behaviour.t) list;  (** what the two leaves become *)
  used : Rule.t list;
}

val candidates :
  Model.t -> State.process -> State.process -> one:int * int -> two:int * int ->
  (unit -> Contact.pair list) -> candidate list
(** [candidates m p q ~one ~two touching]: of a leaf of [p] and one of [q], each with the part that takes part,
    whose features touch as [touching ()] says, which is asked only if it matters. *)

val joined : Model.t -> State.process -> State.process -> candidate -> State.process
(** The two as one process, with the velocity and spin of neither: the caller sets them. *)
