open Scc_data

type into = { first : Int_array.t; choices : Int_array.t }
type t = { mdp : Mdp.t; owner : Int_array.t Lazy.t; into : into Lazy.t }

let owners m =
  let owner = Int_array.make (Mdp.choices m) 0 in
  for s = 0 to Mdp.states m - 1 do
    for c = Mdp.first_choice m s to Mdp.first_choice m (s + 1) - 1 do
      Int_array.set owner c s
    done
  done;
  owner

let turn_round m =
  let n = Mdp.states m in
  (* [first] tells where the choices into a state end at first, and where they begin once all have been put. *)
  let first = Int_array.make (n + 1) 0 in
  let move t by = Int_array.set first t (Int_array.get first t + by) in
  for b = 0 to Mdp.branches m - 1 do
    move (Mdp.target m b) 1
  done;
  for s = 1 to n do
    move s (Int_array.get first (s - 1))
  done;
  let choices = Int_array.make (Mdp.branches m) 0 in
  for c = Mdp.choices m - 1 downto 0 do
    for b = Mdp.first_branch m c to Mdp.first_branch m (c + 1) - 1 do
      let t = Mdp.target m b in
      move t (-1);
      Int_array.set choices (Int_array.get first t) c
    done
  done;
  { first; choices }

let make m = { mdp = m; owner = lazy (owners m); into = lazy (turn_round m) }
let mdp b = b.mdp
let with_mdp b m = { b with mdp = m }
let owner b c = Int_array.get (Lazy.force b.owner) c

let iter b s f =
  let { first; choices } = Lazy.force b.into in
  for i = Int_array.get first s to Int_array.get first (s + 1) - 1 do
    f (Int_array.get choices i)
  done
