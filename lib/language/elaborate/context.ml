open Scc_base
open Scc_exact
open Scc_geometry
open Scc_broad_phase
open Scc_syntax

type template = { shape : Shape.t option; span : Span.t; own : bool; declared : bool; mutable used : bool }

type family = {
  head : Family.head;
  make : Family.reference -> Shape.t option;
  family_span : Span.t;
  family_own : bool;
  mutable instances : int;
}

type source = {
  scope : Env.t;
  source_head : Family.head;
  written : Ast.solid;
  definitions : Ast.definitions;
}

type t = {
  report : Report.t;
  read_file : string -> (string, string) result;
  templates : (string, template) Hashtbl.t;
  made : (string, Shape.t option) Hashtbl.t;
  families : (string, family) Hashtbl.t;
  sources : (string, source) Hashtbl.t;
  mutable nesting : int;
  mutable root : Env.t;
  mutable point : Rat.t array;
  obstacles : Obstacle_cache.t;
  fresh : unit -> int;
  solid : Shape.basic -> Mat.t -> Solid.t;
  scaled : Shape.basic -> Vec.t -> Polyhedron.t * int;
  touching : Obstacle.t -> Vec.t -> Contact.pair list;
}

let hash_with id h = (id * 65599) + h

module By_map = Scc_data.Once.Make (struct
    type t = Shape.basic * Mat.t

    let equal ((a, m) : t) ((b, n) : t) = Int.equal a.id b.id && Mat.equal m n
    let hash ((a, m) : t) = hash_with a.id (Mat.hash m)
  end)

module By_factors = Scc_data.Once.Make (struct
    type t = Shape.basic * Vec.t

    let equal ((a, v) : t) ((b, w) : t) = Int.equal a.id b.id && Vec.equal v w
    let hash ((a, v) : t) = hash_with a.id (Vec.hash v)
  end)

module By_offset = Scc_data.Once.Make (struct
    type t = Obstacle.t * Vec.t

    let equal ((o, v) : t) ((p, w) : t) = Int.equal o.a.id p.a.id && Int.equal o.b.id p.b.id && Vec.equal v w
    let hash ((o, v) : t) = hash_with (hash_with o.a.id o.b.id) (Vec.hash v)
  end)

let counter () =
  let next = ref 0 in
  fun () ->
    let id = !next in
    incr next;
    id

let solids () =
  let fresh = counter () in
  let make ((basic : Shape.basic), linear) = Solid.make ~id:(fresh ()) basic.polyhedron linear in
  let made = By_map.create make in
  fun basic linear -> By_map.find made (basic, linear)

let scalings fresh =
  let make ((basic : Shape.basic), factors) =
    (Polyhedron.transform (Mat.diagonal factors) basic.polyhedron, fresh ())
  in
  let made = By_factors.create make in
  fun basic factors -> By_factors.find made (basic, factors)

let contacts () =
  let made = By_offset.create (fun (o, offset) -> Contact.touching o offset) in
  fun o offset -> By_offset.find made (o, offset)

let create ~read_file =
  let fresh = counter () in
  {
    report = Report.create ();
    read_file;
    templates = Hashtbl.create 16;
    made = Hashtbl.create 16;
    families = Hashtbl.create 16;
    sources = Hashtbl.create 16;
    nesting = 0;
    root = Env.root (Env.scope ~prefix:"" ~file:"" ());
    point = [||];
    obstacles = Obstacle_cache.create ();
    fresh;
    solid = solids ();
    scaled = scalings fresh;
    touching = contacts ();
  }

let copy c =
  let report = Report.copy c.report in
  let templates = Hashtbl.copy c.templates and families = Hashtbl.copy c.families in
  Hashtbl.filter_map_inplace (fun _ (t : template) -> Some { t with used = t.used }) templates;
  Hashtbl.filter_map_inplace (fun _ f -> Some { f with instances = f.instances }) families;
  { c with report; templates; families; made = Hashtbl.copy c.made }

let mark_used c ~by =
  let mark name (t : template) =
    if t.used then Option.iter (fun (same : template) -> same.used <- true) (Hashtbl.find_opt c.templates name)
  in
  Hashtbl.iter mark by.templates

let template_names c =
  let declared name (t : template) all = if t.declared then name :: all else all in
  List.sort String.compare (Hashtbl.fold declared c.templates (Family.keys c.families))
