(** A trajectory for Simularium, as JSON: bodies as agents with meshes, one mesh file for each kind of body
    beside the trajectory; bonds as fibers between the centroids of the bodies; and the events so far, by their
    kinds, as a plot. Its times are evenly spaced. *)

open Scc_exact

val files : Film.t -> path:string -> every:Rat.t option -> Film.file list
(** By default a hundredth of the run lies between two times. *)
