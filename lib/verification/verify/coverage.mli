(** The coverage of a model: the summands of its behaviours that fired, the behaviours that were reached, the
    channels and rules that were used. A count of 0 is certain: if two summands have the same effect, both are
    counted. *)

open Scc_calculus
open Scc_semantics

type t

val create : Model.t -> initial:State.t -> t
(** An empty count for the model, whose summands and behaviours come from the text and the initial state. *)

val explore :
  ?time_seen:Scc_property.Time_seen.t -> Setup.t -> Semantics.t -> initial:State.t -> Explored.t * t
(** Counts all states and transitions while they are explored, within the bounds of the options. States that
    were not expanded, or given up, are not counted. *)

val looked_at : t -> int
(** The number of states that were counted with their transitions. If more states were found, more summands may
    fire. *)

(** A prefix in the body of a definition, or in a behaviour that was written at a body itself. *)
type summand = {
  definition : int option;  (** [None]: written at a body *)
  leaf : int;  (** the first leaf that has the behaviour or may come to it *)
  term : Behaviour.t;  (** [Open], [Weak] or [Strong] *)
  fired : int;  (** transitions that used it *)
}

val summands : t -> summand list
(** All summands, in the order of the definitions; equal summands of one definition are one. Definitions that
    no leaf can ever come to are left out. *)

(** A behaviour that the leaves of a species (a template) may come to, according to their text. *)
type behaviour = { definition : int; species : string; leaf : int;  (** the first of them *) reached : bool }

val behaviours : t -> behaviour list
(** All such behaviours, in the order of the definitions, then of species. *)

(** The numbers of bonds of a name that were made, and that were released by the two kinds of split. *)
type channel = { name : string; made : int; weak : int; strong : int }

val channels : t -> channel list
(** The counts for all names in behaviours, sorted by name. *)

val rules : t -> (Rule.t * int) list
(** The number of transitions that each rule of the model took part in, in the order of [Rule.all]. Eps0 and
    Round are left out, as the graph does not show their use. *)
