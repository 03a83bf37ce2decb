(** The equations, enclosed: intervals that are proved to hold the values, component by component, from those
    that lead nowhere else on. The values are guessed in plain floats, by modified policy iteration (Puterman,
    section 6.5) that goes on to the limit at once where changes have become a geometric sequence. Then a number
    a little less than each guess, and one a little more, are tried, and proved by sweeps that are rounded
    outwards ({!Rounded}): as in optimistic value iteration (Hartmanns and Kaminski, 2020), but on both sides,
    so that nothing depends on how guesses were found. *)

open Scc_exact

type solution = {
  interval : int -> Rat.t * Rat.t option;  (** of each node; [None]: nothing is known above *)
  row : int array;
  (** A row of each node: the values of this scheduler are at least the lower ends, if the greatest values are
      asked for, and at most the upper ends, if the least are. *)
  sweeps : int;  (** how many times all nodes were looked at, by and large *)
}

val solve : Equations.t -> Effort.t -> upper:float -> asked:int array -> solution
(** Until the intervals of the nodes asked for are good enough, or it is interrupted, or floats do not get any
    further. [upper] is at least all values, and may be infinite. *)
