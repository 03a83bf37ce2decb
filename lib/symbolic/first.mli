(** What comes first, of events whose times depend on what is not known. *)

open Scc_polyhedra

(** Of an event, on a region: when it comes, at least 0, or that it never does. *)
type coming = { region : Polyhedron.t; time : Linear.t option }

type 'a cell = {
  region : Polyhedron.t;  (** not empty *)
  time : Linear.t option;  (** when the next of all events comes, if any does *)
  due : 'a list;  (** those that come then, all of them, in the order in which they were given *)
}

val make : Polyhedron.t -> ('a * (Polyhedron.t -> coming list)) list -> 'a cell list
(** [make within events]: regions that are disjoint and make up [within]. Each event tells when it comes on any
    region in it: disjoint regions, none empty, that make up that one. It is asked anew on each region on which
    those before it agree, so that regions stay few. *)
