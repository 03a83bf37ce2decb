open Scc_polyhedra
open Scc_calculus
open Scc_property
open Scc_state_sets

type location = { skeleton : State.t; arrived : int list; set : Polyhedron.t }
type claim = { never : Property.prop; values : Union.t }
type t = { events : Property.event array; locations : location list }

let sizes (m : Model.t) = (Array.length m.ranges, Array.length m.leaves)

let dimension m =
  let parameters, leaves = sizes m in
  parameters + (5 * leaves)

let name (m : Model.t) i =
  let parameters, leaves = sizes m in
  let of_leaf what leaf = Printf.sprintf "%s(%s)" what m.leaves.(leaf).name in
  let j = i - parameters in
  if j < 0 then m.ranges.(i).name
  else if j < leaves then of_leaf "age" j
  else if j < 2 * leaves then of_leaf "clock" (j - leaves)
  else
    let k = j - (2 * leaves) in
    of_leaf [| "x"; "y"; "z" |].(k mod 3) (k / 3)

let zone (m : Model.t) { skeleton; arrived; set } : Zone.t =
  let n = dimension m in
  let parameters, leaves = sizes m in
  let from first count = Array.init count (fun i -> Linear.variable n (first + i)) in
  let places = parameters + (2 * leaves) in
  let place leaf =
    let x = places + (3 * leaf) in
    (Linear.variable n x, Linear.variable n (x + 1), Linear.variable n (x + 2))
  in
  {
    skeleton;
    halted = false;
    arrived;
    set;
    parameters = from 0 parameters;
    time = None;
    ages = from parameters leaves;
    step = None;
    grid = None;
    clocks = from (parameters + leaves) leaves;
    places = Array.init leaves place;
    basis = Array.init n Fun.id;
  }
