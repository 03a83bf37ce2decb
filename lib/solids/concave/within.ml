open Scc_exact
open Scc_geometry

(* The ray goes up from (x + e, y + e'), with e far greater than e', and both smaller than anything else: it meets
   no edge. Of edges seen from above, those count that pass y upwards or downwards on the right of the ray. *)
let over corners (p : Vec.t) =
  let n = Array.length corners in
  let odd = ref false in
  for i = 0 to n - 1 do
    let (a : Vec.t) = corners.(i) in
    let (b : Vec.t) = corners.((i + 1) mod n) in
    let above = Rat.compare a.y p.y > 0 in
    if not (Bool.equal above (Rat.compare b.y p.y > 0)) then begin
      let turn =
        Rat.sub
          (Rat.mul (Rat.sub b.x a.x) (Rat.sub p.y a.y))
          (Rat.mul (Rat.sub b.y a.y) (Rat.sub p.x a.x))
      in
      if (if above then Rat.sign turn < 0 else Rat.sign turn > 0) then odd := not !odd
    end
  done;
  !odd

let meets (n : Vec.t) corners p =
  over corners p
  &&
  let below = Vec.dot n (Vec.sub corners.(0) p) in
  Rat.sign n.z * Rat.sign below > 0

let surface (set : Polyhedron.ifs) faces p =
  let crossed odd f =
    let face = snd set.ifs_faces.(f) in
    let corners = Array.map (fun v -> snd set.ifs_vertices.(v)) face in
    if meets (Drawn.normal set face) corners p then not odd else odd
  in
  List.fold_left crossed false faces
