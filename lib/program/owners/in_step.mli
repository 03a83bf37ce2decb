(** Owners that advance level by level, in step: the numbers, depths and first ways are those of a single search
    that goes breadth first. In each level there are three rounds of messages between all owners
    ({!Mesh.gather}): the end of the states; summaries, with the keys of new states; and their ranks. *)

(** What is asked, and how far it may go. *)
type settings = {
  searches : bool;  (** all that is asked are searches: it ends once every goal is met *)
  most_states : int;
  most_at_once : int option;
  (** no state is expanded whose way ends with more transitions without duration *)
  every : float option;  (** so many seconds between two levels that are kept *)
}

(** What is called on the way. *)
type calls = {
  keep : Progress.t -> unit;  (** the level is to be kept: called by all owners after the same levels *)
  may_keep : unit -> bool;  (** what was kept before is safe; the first owner is asked *)
  show : Progress.t -> unit;  (** after each level *)
  settled : Cycles.graph -> bool;
  (** no more states matter to properties that are no searches: called by all owners after the same levels *)
}

type t

val make : Part.t -> Mesh.t -> Expansion.t -> Levels.t -> settings -> calls -> t
(** One owner. *)

val graph : t -> Cycles.graph
(** What has been explored. *)

val begin_ : t -> home:int -> Progress.t
(** The beginning of an exploration, whose initial state is that of the owner [home]. *)

val run : t -> Progress.t -> Progress.t
(** Goes on from the end of a level to the end of the exploration. All owners do so from the same progress. *)
