(** A trajectory for Simularium, as JSON. Bodies are agents with meshes; each kind of body has a mesh file
    beside the trajectory. Bonds are fibers between the centroids of bodies, and the counts of events so far, by
    kind, are a plot. Its times are evenly spaced. *)

open Scc_exact

val files : Film.t -> path:string -> every:Rat.t option -> Film.file list
(** The trajectory and its mesh files. [every] is the time between two instants (default: a hundredth of the
    run). *)
