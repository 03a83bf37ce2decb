(** Why a formula holds at a position, or why it does not: a tree with runs in it. *)

type t = {
  formula : Formula.t;
  position : Positions.position;
  holds : bool;
  because : because;
}

and because =
  | Given  (** a predicate: it is so *)
  | Parts of t list  (** of not, and, or: the parts that decide it *)
  | Run of { run : Run.t; way : way; parts : t list; along : along option }
  (** a run from the position decides it, with what is so where it leads, and on the way. Of "f until g" that
      holds on some run: g holds there, and f before. Of "f until g" that does not hold on every run: f does not
      hold there, nor does g (but on an open interval that begins so, or before the time of the bound), and g did
      not before; or the run goes on without end, or past the bound, and never meets g. F and G are read as U. For
      X, the last step is the edge. *)
  | Everywhere of int Lazy.t
  (** no run decides it otherwise: all of them together go through these many nodes (0: they do not leave the flow
      of the position) *)
  | Likelihood of { side : Formula.side; measured : Eval.measured; run : (Run.t * Scc_exact.Rat.t) option; parts :
                      t list }
  (** the probability of the operator, over that side; and of a scheduler that attains it a run that does as F or U
      say, or not as G says, with the probability that it comes to be, and what is so where it leads *)

(** Where a run comes from. *)
and way =
  | Own  (** searched for *)
  | Onward of Course.place option
  (** it goes on as the run does along which the formula is explained, to this place of that one ([None]: without
      end, or past the bound) *)

(** What is so on the way of a run: at each of these places, one after the other, by itself. *)
and along = { claim : Formula.t; claimed : bool; course : Course.t; stretches : stretch list }

and stretch = { place : Course.place; why : t Lazy.t }

val explain : Eval.t -> Formula.t -> Positions.position -> t option
(** [None]: undecided there. *)

val goes_on : Run.t -> bool
(** Whether a run is worth following from where another leads. One that only stays in the flow in which it begins,
    to rest there or to pass a bound, would hide the instant at which it begins. *)

val chain : t -> Run.t option
(** The run of the explanation, followed by that of what is so where it leads, and so on: one run from the
    position of the whole explanation (where runs have parts, the first that has a run). *)
