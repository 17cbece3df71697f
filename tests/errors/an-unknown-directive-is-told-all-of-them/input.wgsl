#pragma once
#
# define X
