(** Runs that show why a verdict is as it is, in a form that can be replayed. *)

open Scc_exact
open Scc_calculus
open Scc_semantics

(** A transition of the run. *)
type step = {
  choice : int;  (** its index among the successors *)
  transition : Transition.t;
  time : Rat.t;  (** model time after it *)
}

(** What a round of a run leads to, beside the state that it began in. *)
type moved =
  | Together of Vec.t  (** everything is moved by this *)
  | Apart of (int * Vec.t) list
  (** processes are moved by this each, one told by the first of its leaves: those that never meet again by
      different vectors (rule Drift) *)

(** Where the run is taken to after its steps. *)
type finish =
  | At_state  (** to the state they lead to *)
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
  (** the steps from the index [cycle] on are repeated for ever, each time with everything [moved] from
      where it was; on the way, a weak split that is enabled is put off each time *)
  | Passes of { choice : int option }
  (** the bound of time of the property is passed in the middle of this time transition, or of the ray *)
  | Goes_on of { cycle : int }
  (** over zones (rule Zones): the state is one of the set of states that the step of the index [cycle] began in;
      that some run goes on from there for ever is known of the set, and no state was found that comes back *)

(** Why a formula holds, or does not: a tree of claims. *)
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

(** What a run is one of: the rules over a model with values for its parameters. *)
type fixed = { values : (string * Rat.t) list; semantics : Semantics.t }

type t = {
  initial : State.t;
  steps : step list;
  last : State.t;  (** after the steps *)
  finish : finish;
  facts : string list;  (** what holds there, and with which values, a sentence each *)
  argument : argument option;  (** of a formula with operators within operators *)
  fixed : fixed option;  (** where parameters of the model have ranges *)
}

(** How time ends on the run, when it does: a run in which it goes on and on needs no word. *)
type halt =
  | Dead_end  (** the run is over in a state without transitions *)
  | One_instant  (** the run goes round for ever within one instant *)

val halt : t -> halt option

val semantics : Semantics.t -> t -> Semantics.t
(** Whose run it is: of {!field-fixed}, or else of the one that is given. *)

val choices : t -> int list
(** The choices of the steps. *)

val time : t -> Rat.t
(** Model time after the steps. *)

val instant : t -> Algebraic.t
(** Model time of the instant that the witness is about. *)

val at_rational_instant : t -> bool
(** Whether the run ends at a rational instant, so that {!offset} is exact. *)

val offset : t -> Rat.t option
(** For a schedule: the time to let pass after the steps. At an irrational instant, a rational within
    10^-12 of it. *)

val there : Semantics.t -> t -> State.t
(** The state at the instant that the witness is about, or at the rational one close by ({!offset}). *)

val lines : Model.t -> t -> string list
(** The run in words: the steps, and the {!ending}. *)

val ending : Model.t -> t -> string list
(** Where the run leads, the facts there, and the argument. *)
