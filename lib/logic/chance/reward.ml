open Scc_exact
open Scc_data

let problem q (direction : Equations.direction) : Solution.problem =
  let back = Qualitative.backwards q in
  let m = Backwards.mdp back in
  let goal = Qualitative.goal q in
  let problem ~finite ~allowed ~merged ~choice : Solution.problem =
    let status s : Equations.status =
      if goal s then Known Rat.zero else if Bits.mem finite s then Open else Elsewhere
    in
    { direction; status; elsewhere = Infinite; allowed; merged; rewards = true; choice }
  in
  match direction with
  | Min ->
    let finite = Qualitative.one_max q in
    let allowed c = Mdp.every_branch m c (Bits.mem finite) in
    let inside s = Bits.mem finite s && not (goal s) in
    let free c = allowed c && Rat.sign (Mdp.reward m c) = 0 in
    let merged = Components.ends back ~inside ~allowed:free in
    problem ~finite ~allowed ~merged ~choice:(fun _ -> -1)
  | Max ->
    let avoiding = Qualitative.avoiding q in
    let towards = Qualitative.towards q ~into:(Bits.mem avoiding.set) in
    let finite = Bits.init (Mdp.states m) (fun s -> not (Bits.mem towards.set s)) in
    let choice s = Int.max (Int_array.get avoiding.choice s) (Int_array.get towards.choice s) in
    problem ~finite ~allowed:(fun _ -> true) ~merged:(Components.none m) ~choice

let solve q direction effort ~asked =
  Solution.solve (Qualitative.backwards q) effort ~asked (problem q direction)
