(** What one elaboration shares between its passes: the report, the templates, the solids and obstacles made
    so far. *)

open Scc_base
open Scc_exact
open Scc_geometry
open Scc_broad_phase

type template = {
  shape : Shape.t option;  (** [None] when its faults have been reported *)
  span : Span.t;  (** of its name *)
  mutable used : bool;
}

type t = {
  report : Report.t;
  read_file : string -> (string, string) result;
  templates : (string, template) Hashtbl.t;
  obstacles : Obstacle_cache.t;
  fresh : unit -> int;  (** identities, from 0 *)
  solid : Shape.basic -> Mat.t -> Solid.t;  (** one for each template and linear map *)
  scaled : Shape.basic -> Vec.t -> Polyhedron.t * int;
  (** the scaled image and its [id]: one for each template and factors *)
  touching : Obstacle.t -> Vec.t -> Contact.pair list;  (** {!Contact.touching}, remembered *)
}

val create : read_file:(string -> (string, string) result) -> t

val template_names : t -> string list
(** Sorted. *)
