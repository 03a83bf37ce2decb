(** Properties after elaboration: names resolved, quantifiers over processes expanded (the leaves of a
    network never change), constants folded. *)

open Scc_exact
open Scc_calculus

type axis = Vec.axis = X | Y | Z

(** What a discrete transition does to bonds. *)
type change =
  | Made  (** a bind *)
  | Released_weakly  (** a weak split *)
  | Released_strongly  (** a strong split: any of the bonds that it releases *)
  | Released  (** a weak or a strong split *)

(** Leaves that a pattern of transitions asks for: none in particular, one on either side, two in any
    order. *)
type ends = Any | One of int | Two of int * int

(** A leaf, or one part of it by its index. *)
type spot = { leaf : int; part : int option }

(** A pattern of discrete transitions. *)
type event =
  | Hit of spot * spot option  (** a bounce in which this leaf or part touched another body, or that one *)
  | Bond of change * string option * ends  (** of a bond of this name, between these leaves *)
  | Bounce of ends  (** of the two processes that these are leaves of *)
  | Absorbed of ends  (** of a process by a body, one of which these are leaves of *)

(** Numbers that are read off a state: the atoms among the numbers. Leaves are indices into [Model.leaves]. *)
type quantity =
  | Bonds of string option * (int * int) option
  (** the number of bonds of this name, between these two leaves *)
  | Size of int  (** basic shapes in the leaf's whole process *)
  | Processes
  | Position of axis * int  (** of the centroid of the leaf's own shape *)
  | Velocity of axis * int
  | Speed2 of int
  | Spin of axis * int  (** of the leaf's process *)
  | Spin2 of int
  | Distance2 of int * int  (** between centroids *)
  | Momentum of axis  (** of everything that is not fixed *)
  | Angular of axis
  (** angular momentum of everything that is not fixed, about the origin of the world *)
  | Energy  (** kinetic, of everything that is not fixed *)
  | Time
  | Parameter of int  (** one of which a range is known: an index into {!Scc_calculus.Model.ranges} *)

(** Truths that are read off a state: the atoms among the predicates. *)
type fact =
  | Bound of int * int  (** a bond joins the two leaves *)
  | Same of int * int  (** one process *)
  | Behaviour of int * int
  (** leaf and definition K: the leaf has come to be K and only aged since (reading I-14) *)
  | Offers of int * Behaviour.polarity option * string
  (** the leaf offers a channel of this name now; [None]: of any kind (open with either polarity, weak or
      strong) *)
  | Touching of int * int
  | Gone of int  (** the leaf is in no process any more (rule Absorb) *)
  | Quiescent
  | Event of event
  (** such a transition has led here, and nothing has happened since, nor has time passed: false in the
      initial state and strictly inside a trajectory *)

(** Numbers at a real instant of a run. What of a state each atom depends on is the table of {!Atom}. *)
type num =
  | Const of Rat.t
  | Quantity of quantity
  | Count of prop list  (** how many of these hold *)
  | Neg of num
  | Add of num * num
  | Sub of num * num
  | Mul of num * num
  | Div of num * num
  | If of prop * num * num

(** State predicates: they hold or not at a real instant. *)
and prop =
  | Bool of bool
  | Compare of Law.comparison * num * num
  | Fact of fact
  | Not of prop
  | And of prop list
  | Or of prop list

type side = Scc_ctl.Timed_formula.side = Least | Greatest
type chance = Scc_ctl.Timed_formula.chance = { side : side; test : Scc_chance.Answer.bound }
type path_quantifier = Scc_ctl.Timed_formula.quantifier = All | Exists | Chance of chance

(** Bounds of model time; [low] is 0 but for [[a, b]]. *)
type bound = Scc_ctl.Timed_formula.bound = { low : Rat.t; high : Rat.t option }

type temporal =
  | State of prop
  | Temporal_not of temporal
  | Temporal_and of temporal list
  | Temporal_or of temporal list
  | Next of path_quantifier * temporal
  | Finally of path_quantifier * bound * temporal
  | Globally of path_quantifier * bound * temporal
  | Until of path_quantifier * bound * temporal * temporal

(** What is asked about a formula. *)
type asked =
  | Whether  (** it holds *)
  | How_likely of side list
  (** it is an operator of time of any quantifier: with which probability a run does as it says *)
  | Expected of side list * mean * Scc_chance.Answer.bound option
  (** a mean over the runs, or whether it stands so to a bound; the formula has all atoms that it depends on, up to
      the time at which it does *)

(** Means over runs (rule Expectation). *)
and mean =
  | Time_until of temporal  (** the time until it holds *)
  | Events_until of prop * temporal
  (** the number of transitions of which this is so, until that holds; a combination of events *)
  | Value_at of num * Rat.t  (** at a time *)

type check = {
  name : string;
  span : Scc_base.Span.t;
  text : string;  (** as the printer writes it *)
  asked : asked;
  formula : temporal;
}
