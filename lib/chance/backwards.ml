type t = { mdp : Mdp.t; owner : int array; first : int array; into : int array }

let make m =
  let n = Mdp.states m in
  let owner = Array.make (Mdp.choices m) 0 in
  for s = 0 to n - 1 do
    Array.fill owner (Mdp.first_choice m s) (Mdp.first_choice m (s + 1) - Mdp.first_choice m s) s
  done;
  (* first.(s) is where the choices into s end at first, and where they begin once all have been put. *)
  let first = Array.make (n + 1) 0 in
  for b = 0 to Mdp.branches m - 1 do
    let t = Mdp.target m b in
    first.(t) <- first.(t) + 1
  done;
  for s = 1 to n do
    first.(s) <- first.(s) + first.(s - 1)
  done;
  let into = Array.make (Mdp.branches m) 0 in
  for c = Mdp.choices m - 1 downto 0 do
    for b = Mdp.first_branch m c to Mdp.first_branch m (c + 1) - 1 do
      let t = Mdp.target m b in
      first.(t) <- first.(t) - 1;
      into.(first.(t)) <- c
    done
  done;
  { mdp = m; owner; first; into }

let mdp b = b.mdp
let owner b c = b.owner.(c)

let iter b s f =
  for i = b.first.(s) to b.first.(s + 1) - 1 do
    f b.into.(i)
  done
