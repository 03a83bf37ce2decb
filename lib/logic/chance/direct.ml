let greatest = 8

(* A row of the matrix is what a node asks of the others, and after these its constant. *)
type t = float array

let width = greatest + 1
let room () = Array.make (greatest * width) 0.

(* The equations x = P x + b of the rows. *)
let write (a : t) (r : Rounded.t) ~first ~last =
  let e = r.equations in
  let size = last - first + 1 in
  for i = 0 to size - 1 do
    let base = i * width in
    Array.fill a base size 0.;
    let row = r.row.(first + i) in
    let constant = ref r.below.(row) in
    for k = Equations.first_entry e row to Equations.first_entry e (row + 1) - 1 do
      let w = Equations.node e k in
      if w < first || w > last then constant := !constant +. (e.near.(k) *. r.guess.(w))
      else a.(base + w - first) <- e.near.(k)
    done;
    a.(base + size) <- !constant
  done

(* The probability of going on for ever, below which a scheduler seems to stay. *)
let least = 0x1p-40

(* Each unknown is put into those that come after it: these ask for it no more. All terms are positive, but for 1
   minus what leads back. Whether every unknown was left. *)
let eliminate (a : t) size =
  let rec go k =
    k = size
    ||
    let base = k * width in
    let rest = 1. -. a.(base + k) in
    rest > least
    && begin
      for j = k + 1 to size do
        a.(base + j) <- a.(base + j) /. rest
      done;
      for i = k + 1 to size - 1 do
        let share = a.((i * width) + k) in
        if share > 0. then
          for j = k + 1 to size do
            a.((i * width) + j) <- a.((i * width) + j) +. (share *. a.(base + j))
          done
      done;
      go (k + 1)
    end
  in
  go 0

let evaluate (a : t) (r : Rounded.t) ~first ~last =
  let size = last - first + 1 in
  write a r ~first ~last;
  eliminate a size
  && begin
    for k = size - 1 downto 0 do
      let sum = ref a.((k * width) + size) in
      for j = k + 1 to size - 1 do
        sum := !sum +. (a.((k * width) + j) *. r.guess.(first + j))
      done;
      r.guess.(first + k) <- (if !sum > Rounded.ceiling then Rounded.ceiling else !sum)
    done;
    true
  end
