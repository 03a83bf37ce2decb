(** What of a run a fact about its end does not depend on, tried out.

    A body that took no part in the causes of a fact may still matter by what it did to others: had it not
    deflected them, they might have come in the way. So the run is made again without the bodies that seem to
    be uninvolved. Where that leads elsewhere, as few of them as can be found are put back, and the events in
    which they met the others count as causes: they kept these out of the way. *)

open Scc_property

type role =
  | Irrelevant
  | Cause
  | Keeps_away  (** by it, something else does not come in the way *)

(** Bodies are the processes of the declared state, by their leaves. *)
type body = int list

type t = {
  story : Causes.t;
  basis : Causes.basis;
  roles : role array;  (** by event of the story *)
  facts : string list;  (** the atoms of the fact at the end of the run, with their values *)
  left_out : body list;  (** tried: without all of them, the same happens *)
  keep_away : (body * string) list;  (** that matter by what they keep away, and what differs without them *)
}

val explain : Causes.t -> Causes.basis -> Property.prop list -> t
(** The fact is that the predicates are as they are at the end, and that the run is over there, of a run that says
    so. Without the bodies left out, the events that
    are no longer irrelevant happen at the same times and in the same order, and every atom of the predicates
    has the same truth and values at the end. *)
