open Scc_base
open Scc_exact
open Scc_geometry

type basic = { id : int; root : int; label : string; polyhedron : Polyhedron.t }

type part = {
  name : string;
  basic : basic;
  placement : Affine.t;
  place : Form.place;
  solid : Solid.t;
  mass : Rat.t;
  span : Span.t;
}

type glue = { one : Scc_calculus.Site.t; two : Scc_calculus.Site.t }

type compound = {
  cid : int;
  clabel : string;
  parts : part array;
  open_glues : glue list;
  velocity : Vec.t;
  spin : Vec.t;
  drawn : Scc_concave.Parts.t option;
}

type t = Basic of basic | Compound of compound

let structure = function
  | Basic b -> b.root
  | Compound c -> c.cid

let label = function
  | Basic b -> b.label
  | Compound c -> c.clabel

let polyhedra = function
  | Basic b -> [| b.polyhedron |]
  | Compound c -> Array.map (fun p -> p.basic.polyhedron) c.parts

let part_index c name =
  let rec from i =
    if i = Array.length c.parts then None
    else if String.equal c.parts.(i).name name then Some i
    else from (i + 1)
  in
  from 0
