(** Runs that show the reason for a verdict, in a form that can be replayed. *)

open Scc_exact
open Scc_calculus
open Scc_semantics

(** A transition of the run. *)
type step = {
  choice : int;  (** its index among the successors *)
  transition : Transition.t;
  time : Rat.t;  (** model time after it *)
}

(** The displacement that a round of a run makes, in an otherwise equal state. *)
type moved =
  | Together of Vec.t  (** everything is moved by this *)
  | Apart of (int * Vec.t) list
  (** each process, given by its first leaf, is moved by its vector. Those that never meet again have different
      vectors (rule Drift). *)

(** The end of the run, after its steps. *)
type finish =
  | At_state  (** in the state after the steps *)
  | During of {
      choice : int option;  (** the time transition that is under way; [None] in the last ray of a run *)
      offset : Algebraic.t;  (** the instant, from the start of it *)
      open_piece : bool;
      (** the instant is a sample of the open interval on which the same holds (which it begins, at
          [from]); otherwise it is the instant itself *)
      from : Algebraic.t;
    }
  | Rests of { puts_off : Transition.label option }
  (** nothing happens any more, and time passes for ever; a weak split that is enabled is put off *)
  | Stops  (** the run is over: neither time nor anything else can go on *)
  | Repeats of { cycle : int; moved : moved; puts_off : Transition.label option }
  (** the steps from the index [cycle] on are repeated for ever. Each time everything is [moved] from its
      place. On the way, a weak split that is enabled is put off each time. *)
  | Passes of { choice : int option; offset : Algebraic.t; shown : bool }
  (** The bound of time of the property is passed in the middle of this time transition, or of the ray: at this
      instant, from the start of it. It is not [shown] if bodies turn too often until then; the run then leads to
      the last state. *)
  | Goes_on of { cycle : int }
  (** over zones (rule Zones): the state is in the set of states in which the step of the index [cycle] began.
      Some run goes on for ever from the set. No single state was found that comes back. *)

(** The reason why a formula holds or fails: a tree of claims. *)
type argument = {
  where : string option;
  (** on the run of the claim that it is a part of; [None]: where that run leads, or there *)
  time : Rat.t option;
  (** the same as a time of the run that is shown, if it is on that one; of an irrational instant a rational within
      10^-12 before it *)
  claim : string;
  holds : bool;
  because : string list;  (** a sentence each *)
  parts : argument list;
}

val equal_arguments : argument -> argument -> bool
(** [equal_arguments a b] is true if [a] and [b] are equal in all fields, parts included. *)

(** The rules over a model with values for its parameters. *)
type fixed = { values : (string * Rat.t) list; semantics : Semantics.t }

type t = {
  initial : State.t;
  steps : step list;
  last : State.t;  (** after the steps *)
  finish : finish;
  facts : string list;  (** what holds there, and with which values, a sentence each *)
  argument : argument option;  (** of a formula with operators within operators *)
  fixed : fixed option;  (** where parameters of the model have ranges *)
  otherwise : otherwise option;
}

(** A run that does otherwise, and parts from this one as late as possible ({!Scc_ctl.Contrast}), if it was asked
    for. *)
and otherwise = {
  shared : int;  (** the number of steps that it has in common with this run, at its beginning *)
  run : t;
}

(** The way in which time ends on a run, if it does. *)
type halt =
  | Dead_end  (** the run is over in a state without transitions *)
  | One_instant  (** the run goes round for ever within one instant *)

val passes : Semantics.t -> choice:int option -> Algebraic.t -> State.t -> finish
(** [passes c ~choice offset last] is the end of a run that passes a bound at this offset from its last state. The
    bound is shown if bodies make at most 1 000 turns until then. Turns are computed one by one, and the numbers of
    orientations grow with each. *)

val halt : t -> halt option
(** The way in which time ends on the run; [None] if time goes on. *)

val semantics : Semantics.t -> t -> Semantics.t
(** [semantics m w] are the rules of the run: those of {!field-fixed} if there are any, else [m]. *)

val choices : t -> int list
(** The choices of the steps, in order. *)

val time : t -> Rat.t
(** The model time after the steps. *)

val instant : t -> Algebraic.t
(** The model time of the instant that the witness is about. *)

val at_rational_instant : t -> bool
(** [at_rational_instant w] is true if the run ends at a rational instant, so that {!offset} is exact. *)

val is_before_bound : t -> bool
(** [is_before_bound w] is true if [w] passes a bound that is not shown. *)

val offset : t -> Rat.t option
(** The time to let pass after the steps, for a schedule. At an irrational instant it is a rational within
    10^-12 of it. [None] if the run neither ends [During] a time transition nor [Passes] a bound that is shown. *)

val there : Semantics.t -> t -> State.t
(** The state at the instant that the witness is about, or at the rational one close to it ({!offset}). *)

val lines : Model.t -> t -> string list
(** The run in words: the steps, and the {!ending}. *)

val ending : Model.t -> t -> string list
(** The end of the run in words, the facts there, and the argument. *)
