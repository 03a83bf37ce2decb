open Scc_exact
open Scc_data

let elsewhere : Answer.t = Within (Rat.zero, Rat.one)

let problem q (direction : Equations.direction) : Solution.problem =
  let back = Qualitative.backwards q in
  let zero, one, merged, choice =
    match direction with
    | Min ->
      let zero = Qualitative.avoiding q and one = Qualitative.one_min q in
      (zero.set, one, (fun _ -> Components.none (Backwards.mdp back)), Int_array.get zero.choice)
    | Max ->
      let zero = Qualitative.zero_max q and one = Qualitative.surely q in
      let merged inside = Components.ends back ~inside ~allowed:(fun _ -> true) in
      (zero, one.set, merged, Int_array.get one.choice)
  in
  let at_zero : Equations.status = Known Rat.zero and at_one : Equations.status = Known Rat.one in
  let status s = if Bits.mem zero s then at_zero else if Bits.mem one s then at_one else Equations.Open
  in
  let merged = merged (fun s -> not (Bits.mem zero s || Bits.mem one s)) in
  {
    direction; status; elsewhere; allowed = (fun _ -> true); merged; rewards = false; choice;
  }

let solve q direction effort ~asked =
  Solution.solve (Qualitative.backwards q) effort ~asked (problem q direction)
