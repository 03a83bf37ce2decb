open Scc_base
open Scc_exact
open Scc_geometry
open Scc_broad_phase
open Scc_syntax

type template = { shape : Shape.t option; span : Span.t; own : bool; mutable used : bool }

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

module By_map = Hashtbl.Make (struct
    type t = int * Mat.t

    let equal (i, m) (j, n) = Int.equal i j && Mat.equal m n
    let hash (i, m) = (i * 65599) + Mat.hash m
  end)

module By_factors = Hashtbl.Make (struct
    type t = int * Vec.t

    let equal (i, v) (j, w) = Int.equal i j && Vec.equal v w
    let hash (i, v) = (i * 65599) + Vec.hash v
  end)

module By_offset = Hashtbl.Make (struct
    type t = int * int * Vec.t

    let equal (i, j, v) (k, l, w) = Int.equal i k && Int.equal j l && Vec.equal v w
    let hash (i, j, v) = (((i * 65599) + j) * 65599) + Vec.hash v
  end)

let counter () =
  let next = ref 0 in
  fun () ->
    let id = !next in
    incr next;
    id

let solids () =
  let made = By_map.create 64 and fresh = counter () in
  fun (basic : Shape.basic) linear ->
    let key = (basic.id, linear) in
    match By_map.find_opt made key with
    | Some s -> s
    | None ->
      let s = Solid.make ~id:(fresh ()) basic.polyhedron linear in
      By_map.add made key s;
      s

let scalings fresh =
  let made = By_factors.create 16 in
  fun (basic : Shape.basic) factors ->
    let key = (basic.id, factors) in
    match By_factors.find_opt made key with
    | Some s -> s
    | None ->
      let s = (Polyhedron.transform (Mat.diagonal factors) basic.polyhedron, fresh ()) in
      By_factors.add made key s;
      s

let contacts () =
  let made = By_offset.create 64 in
  fun (o : Obstacle.t) offset ->
    let key = (o.a.Solid.id, o.b.Solid.id, offset) in
    match By_offset.find_opt made key with
    | Some pairs -> pairs
    | None ->
      let pairs = Contact.touching o offset in
      By_offset.add made key pairs;
      pairs

let create ~read_file =
  let fresh = counter () in
  {
    report = Report.create ();
    read_file;
    templates = Hashtbl.create 16;
    families = Hashtbl.create 16;
    sources = Hashtbl.create 16;
    nesting = 0;
    root = Env.root (Env.scope ~prefix:"" ~file:"");
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
  { c with report; templates; families }

let mark_used c ~by =
  let mark name (t : template) =
    if t.used then Option.iter (fun (same : template) -> same.used <- true) (Hashtbl.find_opt c.templates name)
  in
  Hashtbl.iter mark by.templates

let template_names c = List.sort String.compare (Family.keys c.templates @ Family.keys c.families)
