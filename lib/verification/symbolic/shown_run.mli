(** A run over zones that decides a formula, which {!Branching} has proved to exist, with the claims at its
    end. It begins in a sample of the starts for which the formula has this truth value. *)

open Scc_exact
open Scc_property

type finish = Run_search.finish = There | Rests | Passes of Rat.t | Repeats of int | Goes_on of int

(** A position on the run: after so many steps, and perhaps a time after that. *)
type spot = { steps : int; since : Rat.t option }

val equal_spots : spot -> spot -> bool
(** [equal_spots a b] is true if [a] and [b] are the same position of a run. *)

(** A formula, at a position, holds or does not. *)
type claim = { formula : Property.temporal; holds : bool; spot : spot; because : because }

and because =
  | Given  (** the claim is about a state predicate *)
  | Everywhere  (** all runs from there were considered; or the reason is not searched for *)
  | Parts of claim list
  | Run of { finish : finish; until : spot; goal : spot; along : along option; parts : claim list }
  (** The run goes on to the goal, where the parts hold. If [until] differs from the goal, they hold at all
      positions after [until], up to the goal. Or the run ends otherwise, after the steps to the goal. *)

(** A formula with one truth value at all positions of a run before [until], or at all of them. *)
and along = { what : Property.temporal; so : bool; bound : Property.bound  (** from the start *) }

type t = { run : Concrete.t; finish : finish; claim : claim }

val make : Zone_graph.t -> Branching.t -> Property.temporal -> holds:bool -> t option
(** [make graph b formula ~holds] is a run that shows why the formula holds, or fails, for some start. [None]
    if there is no such start or run, or if none was found among the first few thousand. *)
