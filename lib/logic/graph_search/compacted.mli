(** Breadth-first search that keeps of each state a fingerprint, and how it was found: 10 to 16 bytes. It may
    take a new state for a known one, and says how probable that is. *)

open Scc_exact

module Make (L : Lts.S) : sig
  type visitor = {
    found : int -> int array -> unit;  (** a new state: its number, from 0, and its tuple *)
    opened : int -> int array -> Lts.step list -> unit;  (** a state is expanded *)
    enough : unit -> bool;  (** asked before each expansion: whether to stop *)
  }

  (** Who finds the transitions of states; what is found does not depend on it. *)
  type expander = {
    expand : int -> int array -> (Lts.step list, L.fault) Stdlib.result;
    (** of a state and its tuple: all of them ({!Lts.S.successors}). Called by increasing numbers, within an
        attempt *)
    finish : unit -> unit;  (** at the end, whatever that is *)
  }

  type expanding = L.context -> expander
  (** Of a search that begins. *)

  val here : expanding

  type result = {
    size : int;
    transitions : int;
    depth : int;  (** the greatest *)
    arrival : Rat.t;  (** the greatest model time of the paths on which states were found *)
    left : L.fault Explore.reason list;  (** why some states were not expanded, each kind once, but for faults *)
    omission : float;  (** a bound on the probability that some state was left out unseen *)
    path : int -> int list;  (** a shortest path to a state: the choices made *)
    bytes : int;
  }

  val run :
    ?expanding:expanding -> visitor -> capacity:int -> family:(int -> int) ->
    Limits.t -> Limits.surroundings -> L.context -> result
    (** [family], of slots: {!Appearances.create}. What is found, the bound on omissions and any omission depend on
        no numbers that a process has given to things. Of the limits that on time is not observed.
        At most [capacity] states are kept, and no more than the limit. *)
end
