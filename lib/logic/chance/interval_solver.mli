(** {!Equations} solved by intervals that are proved to contain the values, component by component: each after the
    components that it leads to.

    The values are guessed in plain floats, by modified policy iteration (Puterman, section 6.5). Where changes
    have become a geometric sequence, the guess jumps to its limit. Then a number a little less than each guess is
    tried, and one a little more. Sweeps that are rounded outwards prove them ({!Rounded}). That is optimistic
    value iteration (Hartmanns and Kaminski, 2020) on both sides, so that the proof does not depend on how guesses
    were found. *)

open Scc_exact

type solution = {
  interval : int -> Rat.t * Rat.t option;  (** lower and upper bound of each node; [None]: no upper bound *)
  row : int array;
  (** A row of each node. The values of this scheduler are at least the lower bounds if the direction is [Max], and
      at most the upper bounds if it is [Min]. *)
  sweeps : int;  (** the number of visits of nodes, divided by the number of nodes *)
}

val solve : Equations.t -> Effort.t -> upper:float -> asked:int array -> solution
(** [solve e effort ~upper ~asked] narrows the intervals until those of the nodes [asked] are good enough
    ({!Enclosure.good}), or it is interrupted, or floats cannot narrow them further. [upper] is at least all
    values, and may be infinite. *)
