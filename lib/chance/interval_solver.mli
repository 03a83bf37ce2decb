(** The equations, enclosed: intervals that are proved to hold the values, component by component, from those that
    lead nowhere else on. Lower ends by value iteration from 0. Upper ends are guessed when those seem to be near,
    and proved by one more sweep ({!Rounded}); sweeps go up and down by turns. Interval iteration (Haddad and
    Monmege, 2018) has two sequences that come nearer to each other; here the upper one begins near its end, and
    needs no bound of rewards to begin with. *)

open Scc_exact

type solution = {
  interval : int -> Rat.t * Rat.t option;  (** of each node; [None]: nothing is known above *)
  row : int array;
  (** A row of each node: the values of this scheduler are at least the lower ends, if the greatest values are
      asked for, and at most the upper ends, if the least are. *)
  sweeps : int;  (** how many times all nodes were looked at, by and large *)
}

val solve : Equations.t -> Effort.t -> upper:float -> asked:int list -> solution
(** Until the intervals of the nodes asked for are good enough, or it is interrupted, or floats do not get any
    further. [upper] is at least all values, and may be infinite. *)
