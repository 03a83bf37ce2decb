open Scc_data

type kind = Refine.kind = Strong | Branching | Weak

let compose (f : Int_array.t) (p : Refine.partition) =
  let block = Int_array.make (Int_array.length f) 0 in
  for s = 0 to Int_array.length f - 1 do
    Int_array.set block s (Int_array.get p.block (Int_array.get f s))
  done;
  { p with block }

let make kind g (p : Refine.partition) =
  let drop_silent_loops = match kind with Strong -> false | Branching | Weak -> true in
  Graph.merge g (Int_array.get p.block) ~size:p.count ~drop_silent_loops

let branching effort g =
  let collapsed, component = Tau_cycles.collapse g in
  compose component (Refine.coarsest effort Branching collapsed)

let blocks effort kind g =
  match kind with
  | Strong -> Refine.coarsest effort Strong g
  | Branching -> branching effort g
  | Weak ->
    let finer = branching effort g in
    compose finer.block (Refine.coarsest effort Weak (make Branching g finer))
