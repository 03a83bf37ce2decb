(** A cast of turning bodies against {!Scc_naive.Turning}. *)

open Scc_exact
open Scc_rigid

type cast = Motion.t -> Motion.t -> span:Rat.t -> grid:int -> Cast.outcome

val by_sweep : cast
(** What {!Scc_rigid.Sweep} finds, on the grid. *)

type verdict =
  | Agreed
  | Open of string  (** the bodies touch, or nearly so, for a moment, and either answer may be right *)
  | Wrong_time of string  (** a contact, in another cell of the grid *)
  | Missed of string  (** no contact, though they interpenetrate *)
  | Spurious of string  (** a contact, though they do not *)

val resolution : Rat.t

val judge : cast -> Turning_cases.case -> Scc_naive.Turning.first * verdict

(** {1 Many} *)

type tally = {
  mutable checked : int;
  mutable hits : int;  (** by the reference; also those that interpenetrate from the start *)
  mutable agreed : int;
  mutable undecided : int;
  mutable missed : int;
  mutable spurious : int;
  mutable wrong_times : int;
  mutable complaints : string list;  (** the first ten *)
  mutable opened : string list;  (** the first ten *)
}

val tally : unit -> tally

val run :
  cast -> tally -> seed:int -> Turning_cases.kind -> Turning_cases.shape array -> from:int -> count:int -> unit
(** Cases number [from] and so on of the kind; each from a generator of its own. *)

val right : tally -> bool
(** None missed, none spurious, no wrong time, and few are open. *)
