open Scc_exact

let parts = 1_000_000
let unit = Rat.make Z.one (Z.of_int parts)
let of_parts i = Rat.make (Z.of_int i) (Z.of_int parts)

(* The tail grows with the chance, so that the greatest multiple for which it is small is found by halving. *)
let lower ~n ~k ~miss =
  if k = 0 then Rat.zero
  else begin
    let c = Tail.coefficient ~n ~k in
    let rec between low high =
      if high - low <= 1 then of_parts low
      else
        let middle = (low + high) / 2 in
        if Tail.at_most c ~chance:(of_parts middle) miss then between middle high else between low middle
    in
    between 0 parts
  end

let upper ~n ~k ~miss = Rat.sub Rat.one (lower ~n ~k:(n - k) ~miss)
