(** A run over zones that decides a formula: the one that {!Branching} has found to exist, with what holds where it
    leads. It begins in a sample of the starts for which the formula is so. *)

open Scc_exact
open Scc_property

type finish = Run_search.finish = There | Rests | Passes | Repeats of int | Goes_on of int

(** A position on the run: after so many steps, and perhaps a time after that. *)
type spot = { steps : int; since : Rat.t option }

(** A formula, at a position, holds or does not. *)
type claim = { formula : Property.temporal; holds : bool; spot : spot; because : because }

and because =
  | Given  (** of a state predicate *)
  | Everywhere  (** all runs from there were looked at; or the reason is not looked for *)
  | Parts of claim list
  | Run of { finish : finish; until : spot; goal : spot; along : along option; parts : claim list }
  (** the run goes on to the goal, where the parts are so, as they are at all positions from [until], excluded, to
      the goal, if these are not the same; or it ends otherwise, after the steps to the goal *)

(** What is so at all positions of a run before [until], or at all of them. *)
and along = { what : Property.temporal; so : bool; bound : Property.bound  (** from the start *) }

type t = { run : Concrete.t; finish : finish; claim : claim }

val make : Zone_graph.t -> Branching.t -> Property.temporal -> holds:bool -> t option
(** Why the formula holds, or does not, for some start for which that is so, if there is one. [None]: there is no
    such run, or none was found among the first few thousand. *)
