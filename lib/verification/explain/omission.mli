(** The parts of a run on which a fact about its end does not depend, found by experiment.

    A body that took no part in the causes of a fact may still matter. If it had not deflected others, these
    might have come in the way. So the run is made again without the bodies that seem to be uninvolved. If the
    result differs, as few of them as possible are put back. The events in which these met the others then
    count as causes: they kept the others out of the way. *)

open Scc_property

type role =
  | Irrelevant
  | Cause
  | Keeps_away  (** the event prevents something else from coming in the way *)

(** Bodies are the processes of the declared state, by their leaves. *)
type body = int list

type t = {
  story : Causes.t;
  basis : Causes.basis;
  roles : role array;  (** by event of the story *)
  facts : string list;  (** the atoms of the fact at the end of the run, with their values *)
  left_out : body list;  (** tested: without all of them, the same happens *)
  keep_away : (body * string) list;  (** bodies that keep others away, each with the difference that its
                                         absence makes *)
}

val explain : Causes.t -> Causes.basis -> Property.prop list -> t
(** [explain story basis predicates] is the result for the fact that the predicates have their truth values at
    the end of the run. If the story says so, the fact includes that the run is over there. Without the bodies
    left out, the events that are no longer irrelevant happen at the same times and in the same order. Every
    atom of the predicates then has the same truth and values at the end. *)
