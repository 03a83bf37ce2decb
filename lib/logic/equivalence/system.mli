(** A graph as something that moves: by actions and, when it is timed, by letting time pass. *)

open Scc_exact

type t

type position = int
(** A state of the graph, or a place on the way of a passing of time. Positions are numbered as they are met;
    states keep their numbers. *)

val untimed : Graph.t -> t
(** Every label is an action. *)

val timed : Graph.t -> t
(** Labels that {!Label.passing} knows pass time: a state with [time(d)] can wait for any time up to d, and
    nothing but the rest of d can happen before that is over. After any wait by [time(forever)], wherever the graph
    says that it leads, nothing happens any more and time passes for ever. *)

val graph : t -> Graph.t

val known : t -> position -> bool
(** Every move is there. *)

val actions : t -> position -> (int -> position -> unit) -> unit
(** [actions m p f] is [f label target] for each action. *)

val after : t -> position -> int -> position list
(** Where an action leads to. *)

val silent_closure : t -> position list -> position list
(** What [tau*] reaches, the given ones first, each once. *)

(** For how long time can pass before a decision. *)
type patience = Never | For of Rat.t  (** the shortest passing of time *) | Forever

val patience : t -> position -> patience

val shorter : patience -> patience -> patience
(** The lesser; [Never] says nothing. *)

val common : patience -> patience -> Rat.t option
(** The longest time for which neither side meets an instant of its own; [None] when neither can wait. *)

val wait : t -> position -> Rat.t -> position list
(** Where one can be after exactly so long, over any instants on the way. Time is additive. *)

val stuck_waiting : t -> position -> Rat.t -> bool
(** Whether some way of waiting so long meets a state whose moves are not all known before it is over, so that
    {!wait} may lack something. *)
