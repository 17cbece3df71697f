#inlcude <a.wgsl>
