open Scc_verify
open Scc_exchange
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

let loaded text =
  let e = Load.exactly (Load.text (cube ^ text)) in
  match Scc_semantics.Network.initial e.model e.declared with
  | Ok initial -> (e, initial)
  | Error _ -> Alcotest.fail "no initial state"

let explored ?(options = Check.default) text : Exported.t =
  let e, initial = loaded text in
  {
    name = e.name;
    digest = "md5:0";
    parameters = e.parameters;
    checks = e.checks;
    space = Explored.explore options e.model ~initial;
  }

let made ?(unexplored = []) ?(resting = []) transitions : Exported.t =
  let e, initial = loaded "process p = Cube mass 1 [nil]\nprocess q = Cube mass 1 at translate (5,0,0) [nil]" in
  let edge (label, target) = { Explored.label; target } in
  let out = Array.map (fun l -> Array.of_list (List.map edge l)) transitions in
  let space : Explored.t =
    {
      model = e.model;
      size = Array.length out;
      state = (fun _ -> initial);
      edges = Array.get out;
      expanded = (fun i -> not (List.mem i unexplored));
      rests = (fun i -> List.mem i resting);
      stopped_by = [];
      faults = [];
    }
  in
  { name = Some "made"; digest = "md5:0"; parameters = []; checks = []; space }

let written write =
  let b = Buffer.create 1024 in
  write (Buffer.add_string b);
  Buffer.contents b

let labelling ?instants (e : Exported.t) =
  Labelling.make ?instants e.space
    (Array.of_list (State_predicates.of_checks e.space.model e.checks))
