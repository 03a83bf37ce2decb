(** What of a model ever came to be: which summands of its behaviours fired, which behaviours were reached, which
    channels and rules were used. A count of 0 is sure: where two summands do the same, both count. *)

open Scc_calculus
open Scc_semantics

type t

val create : Model.t -> initial:State.t -> t

val state : t -> State.t -> unit
(** Takes in a state (once; again does no harm but costs time). *)

val transition : t -> Transition.t -> unit
(** Takes in a transition of a state that was taken in. *)

val explore :
  ?time_seen:Scc_property.Time_seen.t -> Check.options -> Semantics.t -> initial:State.t -> Explored.t * t
(** Takes in everything that is explored while it is explored, within the bounds of the options: what they leave
    unexpanded, and what is given up, is not counted. *)

val looked_at : t -> int
(** How many states were taken in with their transitions: of fewer states than were found, more may fire. *)

(** A prefix in the body of a definition, or in a behaviour that was written at a body itself. *)
type summand = {
  definition : int option;  (** [None]: written at a body *)
  leaf : int;  (** the first leaf that has the behaviour or may come to it *)
  term : Behaviour.t;  (** [Open], [Weak] or [Strong] *)
  fired : int;  (** transitions that used it *)
}

val summands : t -> summand list
(** In the order of the definitions; those that are equal within one are one. Those of definitions that no leaf
    could ever come to are not among them. *)

(** A behaviour that the leaves of a species (a template) may come to, as far as their text tells. *)
type behaviour = { definition : int; species : string; leaf : int;  (** the first of them *) reached : bool }

val behaviours : t -> behaviour list

(** How often bonds of a name were made, and released by the two kinds of split. *)
type channel = { name : string; made : int; weak : int; strong : int }

val channels : t -> channel list
(** Of all the names in behaviours, sorted. *)

val rules : t -> (Rule.t * int) list
(** In the order of {!Rule.all}, how many transitions each rule took part in. Eps0 is left out: canonical forms
    have it behind them. *)
