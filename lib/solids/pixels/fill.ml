type rule = Nonzero | Even_odd

let unit = Svg_path.unit
let ceil_div a b = if a >= 0 then (a + b - 1) / b else -(-a / b)

(* Of each row the changes of the winding number, by the first column whose centre is not left of the crossing. *)
let polygons (r : Raster.t) rule ~colour polygons =
  let changes = Array.make ((r.width + 1) * r.height) 0 in
  let edge (x0, y0) (x1, y1) =
    if y0 <> y1 then begin
      let step, (xa, ya), (xb, yb) = if y0 < y1 then (1, (x0, y0), (x1, y1)) else (-1, (x1, y1), (x0, y0)) in
      let first = max 0 (ceil_div (ya - (unit / 2)) unit) in
      let last = min (r.height - 1) (ceil_div (yb - (unit / 2)) unit - 1) in
      for row = first to last do
        let y = (row * unit) + (unit / 2) in
        (* The least column with unit * column + unit / 2 >= x, where x = xa + (xb - xa) (y - ya) / (yb - ya). *)
        let d = yb - ya in
        let numerator = ((xa - (unit / 2)) * d) + ((xb - xa) * (y - ya)) in
        let column = max 0 (min r.width (ceil_div numerator (unit * d))) in
        let k = (row * (r.width + 1)) + column in
        changes.(k) <- changes.(k) + step
      done
    end
  in
  let polygon = function
    | [] -> ()
    | first :: _ as corners ->
      let rec go = function
        | a :: (b :: _ as rest) -> edge a b; go rest
        | [ last ] -> edge last first
        | [] -> ()
      in
      go corners
  in
  List.iter polygon polygons;
  for row = 0 to r.height - 1 do
    let winding = ref 0 in
    for column = 0 to r.width - 1 do
      winding := !winding + changes.((row * (r.width + 1)) + column);
      let inside = match rule with Nonzero -> !winding <> 0 | Even_odd -> !winding land 1 <> 0 in
      if inside then begin
        let k = (row * r.width) + column in
        r.colours.(k) <- colour;
        Bytes.set_uint8 r.alphas k 255
      end
    done
  done
