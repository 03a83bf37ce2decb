open Scc_verify
open Scc_loading
open Scc_graphs
open Scc_test_models

let cube =
  {|
shape Cube {
  vertices a (-1,-1,-1)  b (1,-1,-1)  c (1,1,-1)  d (-1,1,-1)
           e (-1,-1,1)   f (1,-1,1)   g (1,1,1)   h (-1,1,1)
  faces    bottom [a,d,c,b]  top [e,f,g,h]  left [a,e,h,d]
           right [b,c,g,f]   front [a,b,f,e]  back [d,h,g,c]
}
|}

let loaded text : Loaded.t * Scc_calculus.State.t =
  let source = Scc_base.Source.make ~name:"model.sc" (cube ^ text) in
  let l = Load.exactly (Loaded.load ~read_file:(fun _ -> Error "no files here") ~overrides:[] source) in
  match Loaded.initial l with
  | Ok initial -> ({ l with origin = { l.origin with digest = "md5:0" } }, initial)
  | Error _ -> Alcotest.fail "no initial state"

let explored ?(options = Setup.default) text : Exported.t =
  let loaded, initial = loaded text in
  { loaded; space = Explored.explore options loaded.semantics ~initial }

let made ?(unexplored = []) ?(resting = []) transitions : Exported.t =
  let l, initial = loaded "process p = Cube mass 1 [nil]\nprocess q = Cube mass 1 at translate (5,0,0) [nil]" in
  let edge (label, target) =
    let chance = if Scc_semantics.Transition.is_drawn label then Some (Scc_semantics.Transition.chance label) else None in
    { Explored.label; chance; target }
  in
  let out = Array.map (fun l -> Array.of_list (List.map edge l)) transitions in
  let space : Explored.t =
    {
      semantics = l.semantics;
      size = Array.length out;
      state = (fun _ -> initial);
      edges = Array.get out;
      expanded = (fun i -> not (List.mem i unexplored));
      rests = (fun i -> List.mem i resting);
      split_step = None;
      stopped_by = [];
      faults = [];
      dead_ends = [];
    }
  in
  { loaded = { l with origin = { l.origin with name = Some "made" } }; space }

let written write =
  let b = Buffer.create 1024 in
  write (Buffer.add_string b);
  Buffer.contents b

let labelling ?instants (e : Exported.t) =
  Labelling.make ?instants e.space
    (Array.of_list (State_predicates.of_checks (Explored.model e.space) e.loaded.checks))
