(** Draws of one instant that are more than the bound of states lets be made. Breadth first, all states before the
    last of these draws are found before the first one after it. If they alone are too many, the bound is met while
    nothing is known but these states. A check that sees no draws has the same answer in all of them (rule
    JoinedDraws). So it is as well known from a few of them, and the exploration can end at once. *)

open Scc_property
open Scc_graph_search
open Scc_state_space

val find : Setup.t -> Network_lts.context -> Property.check list -> Limits.t -> int option
(** [find options c checks limits] is how many bodies draw at the first instant, if no state after their draws can
    be found within the bound of states, and no check sees what is drawn. It is [None] if that is not known, or if
    all that is explored counts: for another order than by steps, a bound of depth, or an observer. *)

val few : Limits.t -> Limits.t
(** [few limits] is [limits] with a bound of at most 1024 states. *)

val confirmed : State_graph.t -> bool
(** [confirmed g] is true of a graph that was explored with {!few} limits if more of it would not matter: what is
    known is known without more states, or all states are of the first instant and hardly any was found twice. *)
