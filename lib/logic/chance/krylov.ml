open Scc_data
open Enclosure

let least = 5_000
let iterations = 500

(* The rows of a component, by places from its first node on. A link asks for one other node alone, which is no
   link. *)
type rows = {
  r : Rounded.t;
  first : int;
  size : int;
  link : int array;  (** the entry of a link; else -1 *)
  filled : float array;
}

let is_chain (e : Equations.t) part =
  Equations.first_row e (part.last + 1) - Equations.first_row e part.first = size part

let iter_entries rows k f =
  let e = rows.r.Rounded.equations in
  let row = rows.r.row.(rows.first + k) in
  for i = Equations.first_entry e row to Equations.first_entry e (row + 1) - 1 do
    f i (Equations.node e i - rows.first)
  done

let is_inside rows k = k >= 0 && k < rows.size

let rows (r : Rounded.t) part =
  let e = r.equations and n = size part in
  let rows = { r; first = part.first; size = n; link = Array.make n (-1); filled = Array.make n 0. } in
  let is_asked_by_links = Array.make n false in
  for k = 0 to n - 1 do
    let row = r.row.(part.first + k) in
    let i = Equations.first_entry e row in
    if Equations.first_entry e (row + 1) = i + 1 && not is_asked_by_links.(k) then begin
      let target = Equations.node e i - part.first in
      if is_inside rows target && target <> k && rows.link.(target) < 0 then begin
        rows.link.(k) <- i;
        is_asked_by_links.(target) <- true
      end
    end
  done;
  rows

(* Links follow the others; then y is x - P x elsewhere, and 0 at links. *)
let apply rows (x : float array) (y : float array) =
  let e = rows.r.Rounded.equations in
  let filled = rows.filled and near = e.near and node = e.node in
  Array.blit x 0 filled 0 rows.size;
  Array.iteri
    (fun k i ->
       if i >= 0 then filled.(k) <- near.(i) *. x.(Int_array.get node i - rows.first))
    rows.link;
  for k = 0 to rows.size - 1 do
    if rows.link.(k) >= 0 then y.(k) <- 0.
    else begin
      let row = Array.unsafe_get rows.r.row (rows.first + k) in
      let sum = ref 0. in
      for i = Int_array.unsafe_get e.first_entry row to Int_array.unsafe_get e.first_entry (row + 1) - 1 do
        let j = Int_array.unsafe_get node i - rows.first in
        if j >= 0 && j < rows.size then sum := !sum +. (Array.unsafe_get near i *. Array.unsafe_get filled j)
      done;
      y.(k) <- filled.(k) -. !sum
    end
  done

(* What a right side is more than the guess. *)
let lacks rows k =
  let near = rows.r.Rounded.equations.near and guess = rows.r.guess in
  let sum = ref rows.r.below.(rows.r.row.(rows.first + k)) in
  iter_entries rows k (fun i j -> sum := !sum +. (near.(i) *. guess.(rows.first + j)));
  !sum -. guess.(rows.first + k)

let follow_links rows =
  let guess = rows.r.Rounded.guess in
  let follow k i = if i >= 0 then guess.(rows.first + k) <- guess.(rows.first + k) +. lacks rows k in
  Array.iteri follow rows.link

let dot (a : float array) (b : float array) =
  let sum = ref 0. in
  for k = 0 to Array.length a - 1 do
    sum := !sum +. (Array.unsafe_get a k *. Array.unsafe_get b k)
  done;
  !sum

(* a := a + c b *)
let add (a : float array) c (b : float array) =
  for k = 0 to Array.length a - 1 do
    Array.unsafe_set a k (Array.unsafe_get a k +. (c *. Array.unsafe_get b k))
  done

(* The method BiCGSTAB, with the names of the literature, for (I - P) x = b; whether little is left of b. *)
let solve rows ~worked (b : float array) (x : float array) =
  let n = rows.size in
  let r = Array.copy b and v = Array.make n 0. and p = Array.make n 0. and t = Array.make n 0. in
  let enough = 1e-26 *. dot b b in
  let usable c = Float.is_finite c && c <> 0. in
  let rec go left ~rho ~alpha ~omega =
    let next = dot b r in
    let beta = next /. rho *. (alpha /. omega) in
    if left > 0 && usable next && Float.is_finite beta then begin
      worked ();
      add p (-.omega) v;
      Array.iteri (fun k pk -> p.(k) <- r.(k) +. (beta *. pk)) p;
      apply rows p v;
      let alpha = next /. dot b v in
      if usable alpha then begin
        add r (-.alpha) v;
        apply rows r t;
        let omega = dot t r /. dot t t in
        if usable omega then begin
          add x alpha p;
          add x omega r;
          add r (-.omega) t;
          if dot r r > enough then go (left - 1) ~rho:next ~alpha ~omega
        end
      end
    end
  in
  go iterations ~rho:1. ~alpha:1. ~omega:1.;
  dot r r <= 1e-12 *. dot b b

let approach t (r : Rounded.t) part =
  if size part >= least && is_chain r.equations part then begin
    let rows = rows r part in
    follow_links rows;
    let b = Array.init rows.size (fun k -> if rows.link.(k) >= 0 then 0. else lacks rows k) in
    let x = Array.make rows.size 0. in
    if solve rows ~worked:(fun () -> worked t (2 * rows.size)) b x then begin
      Array.iteri
        (fun k d ->
           let better = r.guess.(part.first + k) +. d in
           r.guess.(part.first + k) <- Float.max 0. (Float.min Rounded.ceiling better))
        x;
      follow_links rows
    end
  end
