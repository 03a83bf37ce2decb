(** Breadth-first search with hash compaction: for each state it keeps a fingerprint and the way to it, in 10 to 16
    bytes. It may take a new state for a known one, and bounds the probability of that. *)

open Scc_exact

module Make (L : Lts.S) : sig
  type visitor = {
    found : int -> int array -> unit;  (** a new state: its number, from 0, and its tuple *)
    opened : int -> int array -> Lts.step list -> unit;  (** a state is expanded *)
    enough : unit -> bool;  (** called before each expansion: [true] ends the search *)
  }

  (** The way in which transitions of states are computed. The result of the search does not depend on it. *)
  type expander = {
    expand : int -> int array -> (Lts.step list, L.fault) Stdlib.result;
    (** All transitions of a state, given its number and its tuple ({!Lts.S.successors}). It is called by
        increasing numbers, within an attempt. *)
    finish : unit -> unit;  (** called at the end of the search, also after an exception *)
  }

  type expanding = L.context -> expander
  (** The expander of a search that begins. *)

  val here : expanding
  (** The expander that calls {!Lts.S.successors} in this process. *)

  type result = {
    size : int;  (** the number of states found *)
    transitions : int;  (** the number of transitions of all expanded states *)
    depth : int;  (** the greatest depth of a state *)
    arrival : Rat.t;  (** the greatest model time of the paths on which states were found *)
    left : L.fault Explore.reason list;
    (** The reasons why some states were not expanded: each kind once, and each fault. *)
    omission : float;  (** a bound on the probability that some state was taken for a known one *)
    path : int -> int list;  (** a shortest path to a state, as the choices made *)
    bytes : int;  (** about how much memory the search takes, in bytes *)
  }

  val run :
    ?expanding:expanding -> visitor -> capacity:int -> family:(int -> int) ->
    Limits.t -> Limits.surroundings -> L.context -> result
    (** [run visitor ~capacity ~family limits surroundings context] explores the system. [family] is as in
        {!Appearances.create}: the states found, the bound on omissions and any omission do not depend on the
        numbers in this process. The limit on time is ignored. At most [capacity] states are kept, and no more than
        the limit. *)
end
